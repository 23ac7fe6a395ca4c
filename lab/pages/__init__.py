"""The documentation's pages: documents, the equations of every stock machine, the API."""
