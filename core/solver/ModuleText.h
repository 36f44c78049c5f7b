// Makes text from a plugin safe to show. It is third-party text of any length and content.
#pragma once

#include "base/OneLine.h"

namespace dipwright {

// Returns the text in one line, shortened to fit into a sentence; empty if it has no visible
// characters.
inline QString moduleText(const QString& said) {
    constexpr int mostLetters = 500;
    return oneLine(said).simplified().left(mostLetters);
}

} // namespace dipwright
