"""Pictures of assets without graphics hardware: one piece, or a contact sheet, closed and open."""
