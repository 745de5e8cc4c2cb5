"""Foreign files read with bounded memory and nothing executed, made into assets of this project's frame."""
