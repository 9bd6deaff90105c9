// see docs/page.md
