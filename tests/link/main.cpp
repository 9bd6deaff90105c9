// SPDX-License-Identifier: BSD-3-Clause
// A function in a header that is neither inline nor a template is defined twice here and does not link.
int from_a();
int from_b();

int main() { return from_a() + from_b(); }
