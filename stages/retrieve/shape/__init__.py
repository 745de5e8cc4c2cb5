"""A 32-number description of an asset's shape: a variational autoencoder over its surface. Only `vae` and `train` need torch."""
