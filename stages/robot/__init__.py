"""What a mobile robot reaches, handles and is stopped by."""
