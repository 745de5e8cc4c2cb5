"""An apartment as the bodies that simulators and pictures are made of."""
