"""An apartment as the bodies that simulators and pictures are made of, the building included, and its pictures."""
