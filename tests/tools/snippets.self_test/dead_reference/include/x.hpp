// see docs/gone.md
