// What a plugin says in words: a stranger's, of any length and with anything in it.
#pragma once

#include "base/OneLine.h"

namespace dipwright {

// As much of it as may stand within a sentence, in one line; empty where there is nothing to read.
inline QString moduleText(const QString& said) {
    constexpr int mostLetters = 500;
    return oneLine(said).simplified().left(mostLetters);
}

} // namespace dipwright
