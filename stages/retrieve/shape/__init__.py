"""32 numbers that describe an asset's shape: a variational autoencoder. Only `vae` and `train` need torch."""
