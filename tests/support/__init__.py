"""What tests run things with: a stand-in core, a browser, a terminal, the command line."""
