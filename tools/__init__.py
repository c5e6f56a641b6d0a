"""What makes pages and pictures of the documentation from the program; not part of the package."""
