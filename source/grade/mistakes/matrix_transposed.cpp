#include "source/grade/Changes.h"
#include "source/grade/Mistake.h"

namespace ray::grade {

extern const Mistake matrix_transposed_mistake{
    .name = "matrix_transposed",
    .title = "matrices are read by columns",
    .expected = "Matrices are in row-major order, for column vectors: the translation is the last column.",
    .hint = "Do things turn the other way round?",
    .make =
        [](Variant& v) {
          ChangeTransforms(v.OwnScene(), [](const R3::Matrix& matrix) {
            R3::Matrix transposed = matrix;
            for (std::size_t i = 0; i < 3; ++i)
              for (std::size_t j = 0; j < 3; ++j) transposed.m[i][j] = matrix.m[j][i];
            return transposed;
          });
        },
};

}  // namespace ray::grade
