"""Finding the asset for a box, and the box's place once the asset is known."""
