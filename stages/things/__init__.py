"""What things are: categories, materials, assets, bodies, what carries them."""
