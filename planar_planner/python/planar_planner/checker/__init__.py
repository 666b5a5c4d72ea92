"""The checker of certificates (docs/certificate.md), in exact arithmetic."""
