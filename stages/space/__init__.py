"""Plane geometry: polygons, oriented boxes, grids, swept volumes, and graphs of rooms."""
