"""Layout: a guided set diffusion model places every object of an apartment (paper 3.2-3.4, Algorithm 1)."""
