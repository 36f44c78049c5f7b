// Texts of strangers, to be shown within a line.
#pragma once

#include <QString>

#include <algorithm>

namespace dipwright {

// With a space in the place of each character that would end the line, move within it or do
// anything else but be seen.
inline QString oneLine(QString text) {
    std::replace_if(
        text.begin(), text.end(),
        [](QChar letter) {
            return letter.category() == QChar::Other_Control ||
                   letter.category() == QChar::Separator_Line ||
                   letter.category() == QChar::Separator_Paragraph;
        },
        u' ');
    return text;
}

} // namespace dipwright
