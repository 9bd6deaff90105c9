// A program.
  // [sum]
  std::array<int, 2> a{1, 2};  // $ \ ; []

  int sum = a[0] + a[1];
  // [/sum]
