#pragma once

// Partial derivatives (i, j, k) by x, y and z, numbered in ascending order i + j + k; for example the number
// 1 is (1, 0, 0). This file contains no functions that a compiler could emit, so that kernels can include it.

namespace beadswim {

constexpr int max_derivative_order = 8;

struct DerivativeTable {
  static constexpr int size = 165;
  int degree[size][3]{};                  ///< (i, j, k) of each derivative
  int order[size]{};                      ///< i + j + k of each derivative
  int index[9][9][9]{};                   ///< number of the derivative (i, j, k)
  int first[max_derivative_order + 2]{};  ///< number of the first derivative of each order
};
constexpr DerivativeTable derivative_table = [] {
  DerivativeTable table;
  int count = 0;
  for (int order = 0; order <= max_derivative_order; ++order) {
    table.first[order] = count;
    for (int i = order; i >= 0; --i) {
      for (int j = order - i; j >= 0; --j) {
        const int k = order - i - j;
        table.degree[count][0] = i, table.degree[count][1] = j, table.degree[count][2] = k;
        table.order[count] = order;
        table.index[i][j][k] = count++;
      }
    }
  }
  table.first[max_derivative_order + 1] = count;
  return table;
}();

/// Returns the number of derivatives up to `order`: 1, 4, 10, 20, ...
constexpr int derivative_count(int order) {
  return derivative_table.first[order + 1];
}

}  // namespace beadswim
