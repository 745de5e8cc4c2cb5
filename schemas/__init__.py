"""What every artifact holds: pydantic types, their envelope, reading and writing."""
