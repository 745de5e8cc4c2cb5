"""What things are: categories, materials, assets, bodies, the building's own parts."""
