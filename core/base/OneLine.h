// Makes text from untrusted sources safe to show within one line.
#pragma once

#include <QString>

#include <algorithm>
#include <utility>

namespace dipwright {

// Whether a character is invisible but changes how its neighbours look. U+202E, for example,
// reverses their order. Returns false for characters that only join or separate the letters of a
// word.
inline bool isInvisibleFormat(QChar letter) {
    constexpr char16_t softHyphen = 0x00ad, nonJoiner = 0x200c, joiner = 0x200d;
    return letter.category() == QChar::Other_Format && letter != softHyphen &&
           letter != nonJoiner && letter != joiner;
}

// Replaces each character for which isInvisibleFormat() is true by U+FFFD, which is visible.
inline QString withVisibleFormats(QString text) {
    std::replace_if(text.begin(), text.end(), isInvisibleFormat,
                    QChar(QChar::ReplacementCharacter));
    return text;
}

// Replaces each control character and line separator by a space. Invisible format characters become
// U+FFFD.
inline QString oneLine(QString text) {
    std::replace_if(
        text.begin(), text.end(),
        [](QChar letter) {
            return letter.category() == QChar::Other_Control ||
                   letter.category() == QChar::Separator_Line ||
                   letter.category() == QChar::Separator_Paragraph;
        },
        u' ');
    return withVisibleFormats(std::move(text));
}

} // namespace dipwright
