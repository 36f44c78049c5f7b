// Texts of strangers, to be shown within a line.
#pragma once

#include <QString>

#include <algorithm>
#include <utility>

namespace dipwright {

// Whether a letter is not seen itself but can change how others are: turn their order round, as
// U+202E does, or stand between them unseen. Those that join letters into one may stay.
inline bool isUnseenFormat(QChar letter) {
    constexpr char16_t softHyphen = 0x00ad, nonJoiner = 0x200c, joiner = 0x200d;
    return letter.category() == QChar::Other_Format && letter != softHyphen &&
           letter != nonJoiner && letter != joiner;
}

// With U+FFFD, which is seen, in the place of each of these.
inline QString inReadingOrder(QString text) {
    std::replace_if(text.begin(), text.end(), isUnseenFormat, QChar(QChar::ReplacementCharacter));
    return text;
}

// With a space in the place of each character that would end the line, move within it or do
// anything else but be seen; in reading order.
inline QString oneLine(QString text) {
    std::replace_if(
        text.begin(), text.end(),
        [](QChar letter) {
            return letter.category() == QChar::Other_Control ||
                   letter.category() == QChar::Separator_Line ||
                   letter.category() == QChar::Separator_Paragraph;
        },
        u' ');
    return inReadingOrder(std::move(text));
}

} // namespace dipwright
