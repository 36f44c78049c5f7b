#include "import/sandboxed/ObjText.h"

#include "import/sandboxed/MaterialFileCheck.h"

#include <QCoreApplication>

#include <algorithm>
#include <cctype>
#include <utility>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::ImportModel)
};

bool isBlank(char byte) {
    return std::isspace(uchar(byte)) != 0;
}

bool isLineEnd(char byte) {
    return byte == '\n' || byte == '\r';
}

// Removes and returns the first word of a line; empty if there is none.
QByteArrayView takeWord(QByteArrayView& line) {
    const auto begin = std::find_if_not(line.begin(), line.end(), isBlank);
    const auto end = std::find_if(begin, line.end(), isBlank);
    line = QByteArrayView(end, line.end());
    return {begin, end};
}

// Whether a word stands for a value that is no number: nan, inf, 1.#IND.
bool isNoNumber(QByteArrayView word) {
    constexpr QByteArrayView letters = "nNiI";
    return std::any_of(word.begin(), word.end(), [&](char byte) { return letters.contains(byte); });
}

bool beginsAsNumber(QByteArrayView word) {
    const auto digit = std::find_if_not(word.begin(), word.end(), [](char byte) {
        return byte == '+' || byte == '-' || byte == '.';
    });
    return digit != word.end() && std::isdigit(uchar(*digit)) != 0;
}

// Whether assimp would read a number as 0, because its whole part has too many digits.
bool isTooLong(QByteArrayView word) {
    constexpr std::ptrdiff_t mostDigits = 19;
    const auto digits = std::find_if_not(word.begin(), word.end(), [](char byte) {
        return byte == '+' || byte == '-' || std::isdigit(uchar(byte)) != 0;
    });
    return digits - word.begin() > mostDigits;
}

class ObjText {
public:
    explicit ObjText(const ModelSource& source)
        : source_(source), bytes_(withoutByteOrderMark(source.bytes)), rest_(bytes_) {}

    QByteArray forAssimp() {
        text_.reserve(bytes_.size());
        while (!rest_.isEmpty()) {
            ++line_;
            const QByteArrayView line = takeLine();
            if (line.endsWith('\\')) {
                const QByteArray whole = continued(line);
                addLine(whole);
            } else {
                addLine(line);
            }
        }
        return text_;
    }

private:
    QByteArrayView takeLine() {
        const auto end = std::find_if(rest_.begin(), rest_.end(), isLineEnd);
        const QByteArrayView line(rest_.begin(), end);
        const QByteArrayView after(end, rest_.end());
        rest_ = after.sliced(after.startsWith("\r\n") ? 2 : std::min<qsizetype>(after.size(), 1));
        return line;
    }

    // Returns a line together with the lines that continue it. A comment has none.
    QByteArray continued(QByteArrayView begin) {
        QByteArray whole = begin.toByteArray();
        while (whole.endsWith('\\') && !whole.trimmed().startsWith('#')) {
            whole.back() = ' ';
            whole += takeLine();
            ++continuations_;
        }
        return whole;
    }

    void addLine(QByteArrayView line) {
        const QByteArrayView whole(std::find_if_not(line.begin(), line.end(), isBlank), line.end());
        QByteArrayView rest = whole;
        const QByteArrayView keyword = takeWord(rest);
        if (keyword == "v" || keyword == "vt" || keyword == "vn") {
            addNumbers(keyword, rest);
        } else if (keyword == "f" || keyword == "l" || keyword == "p") {
            text_ += keyword;
            for (auto word = takeWord(rest); isData(word); word = takeWord(rest)) {
                addWord(word);
            }
        } else if (!keyword.startsWith('#')) {
            text_ += whole;
        }
        text_ += '\n';
        line_ += std::exchange(continuations_, 0);
    }

    static bool isData(QByteArrayView word) { return !word.isEmpty() && !word.startsWith('#'); }

    void addWord(QByteArrayView word) {
        text_ += ' ';
        text_ += word;
    }

    void addNumbers(QByteArrayView keyword, QByteArrayView rest) {
        const bool isPoint = keyword == "v";
        int count = 0;
        double fourth = 1;
        text_ += keyword;
        for (auto word = takeWord(rest); isData(word); word = takeWord(rest)) {
            if (isNoNumber(word) && keyword != "vn") {
                addWord(isPoint ? "nan" : "9e9");
                ++count;
                continue;
            }
            addWord(word.startsWith('.') ? "0" : "");
            if (isTooLong(word)) {
                text_ += QByteArray::number(word.toDouble(), 'g', 9);
            } else {
                text_ += word;
            }
            count += beginsAsNumber(word) ? 1 : 0;
            fourth = count == 4 && isPoint ? word.toDouble() : fourth;
        }
        if (isPoint) {
            checkPoint(count, fourth);
        }
    }

    // Three numbers, and then a weight of 1 or a colour.
    void checkPoint(int count, double fourth) const {
        if (count != 3 && count != 4 && count != 6) {
            source_.throwDamaged(Text::tr("its line %1 gives a point by %2 numbers instead of 3")
                                     .arg(line_)
                                     .arg(count));
        }
        if (count == 4 && fourth != 1) {
            source_.throwDamaged(Text::tr("its line %1 gives a point the weight %2, which programs "
                                          "read in different ways")
                                     .arg(line_)
                                     .arg(fourth));
        }
    }

    const ModelSource& source_;
    const QByteArray bytes_;
    QByteArrayView rest_; // of the bytes
    QByteArray text_;
    qint64 line_ = 0, continuations_ = 0;
};

} // namespace

QByteArray objForAssimp(const ModelSource& source) {
    return ObjText(source).forAssimp();
}

} // namespace dipwright
