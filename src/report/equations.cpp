#include "report/equations.h"

namespace twrench::report {

Section equations() {
  return {
      .heading = "Equations",
      .content = {
          Formula{"<mover><mi>X</mi><mo>˙</mo></mover><mo>=</mo><mi>X</mi><mover><mi>ω</mi>"
                  "<mo>^</mo></mover><mo>,</mo><mspace width=\"1em\"/><mi>ω</mi><mo>=</mo>"
                  "<msup><mi>I</mi><mrow><mo>−</mo><mn>1</mn></mrow></msup><msup><mi>X</mi>"
                  "<mi>T</mi></msup><mi>L</mi>",
                  R"(\dot X = X\hat\omega,\quad \omega = I^{-1}X^{T}L)",
                  "The motion, eq. (19)-(20) of [1]: X takes body axes to space, X(0) = Id; ω in "
                  "body axes, L in space."},
          Formula{"<mi>T</mi><mo>=</mo><mfrac><mn>1</mn><mn>2</mn></mfrac><mi>ω</mi><mo>·</mo>"
                  "<mi>I</mi><mi>ω</mi><mo>,</mo><mspace width=\"1em\"/><mi>L</mi><mo>=</mo>"
                  "<mi>X</mi><mi>I</mi><mi>ω</mi>",
                  R"(T = \tfrac12\,\omega\cdot I\omega,\quad L = X I\omega)",
                  "What the motion conserves, eq. (12) and (14) of [1]."},
          Formula{"<msub><mi>t</mi><mi>n</mi></msub><mo>=</mo><msub><mi>t</mi><mn>1</mn></msub>"
                  "<mo>+</mo><mo>(</mo><mi>n</mi><mo>−</mo><mn>1</mn><mo>)</mo><mfrac><mrow>"
                  "<mn>2</mn><mi>K</mi><mo>(</mo><mi>m</mi><mo>)</mo></mrow><mrow><mo>|</mo>"
                  "<mi>λ</mi><mo>|</mo></mrow></mfrac>",
                  R"(t_n = t_1 + (n-1)\,\frac{2K(m)}{|\lambda|})",
                  "The flips, where ω along the intermediate axis changes sign [2, 3]: K is the "
                  "complete elliptic integral of the parameter m, λ the rate of its argument."},
          Formula{"<msub><mi>e</mi><mi>X</mi></msub><mo>=</mo><msub><mrow><mo>‖</mo><mi>X</mi>"
                  "<mo>−</mo><msub><mi>X</mi><mtext>exact</mtext></msub><mo>‖</mo></mrow>"
                  "<mi>F</mi></msub><mo>,</mo><mspace width=\"1em\"/><msub><mi>e</mi><mi>T</mi>"
                  "</msub><mo>=</mo><mrow><mo>|</mo><mi>T</mi><mo>/</mo><msub><mi>T</mi><mn>0</mn>"
                  "</msub><mo>−</mo><mn>1</mn><mo>|</mo></mrow><mo>,</mo><mspace width=\"1em\"/>"
                  "<msub><mi>e</mi><mtext>SO(3)</mtext></msub><mo>=</mo><msub><mrow><mo>‖</mo>"
                  "<msup><mi>X</mi><mi>T</mi></msup><mi>X</mi><mo>−</mo><mi>Id</mi><mo>‖</mo>"
                  "</mrow><mi>F</mi></msub>",
                  R"(e_X = \|X - X_\text{exact}\|_F,\quad e_T = |T/T_0 - 1|,\quad )"
                  R"(e_{SO(3)} = \|X^{T}X - Id\|_F)",
                  "The errors in the tables."},
      }};
}

}  // namespace twrench::report
