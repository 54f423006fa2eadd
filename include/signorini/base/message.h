// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <signorini/base/errors.h>

#include <sstream>
#include <string>

namespace Signorini {
/** Returns the parts of a sentence, texts and numbers with six digits, one behind the other. */
template <typename... Parts>
std::string concatenate(const Parts &...parts) {
  std::ostringstream text;
  (text << ... << parts);
  return text.str();
}

/** Returns "(0, 1.5)": a vector or a point with six digits. */
template <typename Vector>
std::string vector_text(const Vector &x) {
  std::string text;
  for (unsigned int d = 0; d < Vector::dimension; ++d)
    text += concatenate(d == 0 ? "(" : ", ", x[d] + 0.); // no -0
  return text + ")";
}

/** Returns the error with these parts of its sentence. */
template <typename... Parts>
InputError input_error(const Parts &...parts) {
  return InputError(concatenate(parts...));
}
} // namespace Signorini
