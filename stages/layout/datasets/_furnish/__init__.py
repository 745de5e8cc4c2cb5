"""The rule-and-search furnisher: rooms' shapes, poses worth trying, and the rules by room type."""
