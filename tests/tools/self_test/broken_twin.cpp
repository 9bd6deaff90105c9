// SPDX-License-Identifier: BSD-3-Clause
// expect: never reached
int twin = "broken";
