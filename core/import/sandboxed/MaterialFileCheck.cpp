#include "import/sandboxed/MaterialFileCheck.h"

#include <QCoreApplication>
#include <QStringConverter>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <vector>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::ImportModel)
};

bool startsWithAny(QByteArrayView line, std::initializer_list<const char*> words,
                   Qt::CaseSensitivity sensitivity) {
    return std::any_of(words.begin(), words.end(), [&](const char* word) {
        const auto size = qsizetype(qstrlen(word));
        return line.size() >= size && line.first(size).compare(word, sensitivity) == 0;
    });
}

// Whether assimp needs a current material at this line. It does for pictures and for the values of
// physically based materials. It skips any other line, even a heading such as "Alias OBJ Material
// File".
bool needsMaterial(QByteArrayView line) {
    return startsWithAny(line, {"map_", "bump", "disp", "decal", "refl", "norm"},
                         Qt::CaseInsensitive) ||
           startsWithAny(line, {"a", "Pr", "Pm", "Ps", "Pc"}, Qt::CaseSensitive);
}

QByteArrayView firstWord(QByteArrayView line) {
    return {line.begin(), std::find_if(line.begin(), line.end(),
                                       [](char byte) { return byte == ' ' || byte == '\t'; })};
}

// Whether the line names a picture. A heading may begin with the same letters, so the whole first
// word counts.
bool isPicture(QByteArrayView line) {
    const QByteArray word = firstWord(line).toByteArray().toLower();
    return word.startsWith("map_") || word == "bump" || word == "disp" || word == "decal" ||
           word == "refl" || word == "norm";
}

bool endsLine(char byte) {
    return byte == '\n' || byte == '\r' || byte == '\f' || byte == '\0';
}

// Keywords that assimp recognises only with these capitals. Some programs write others.
constexpr const char* knownWords[] = {"newmtl", "map_Kd", "Kd"};

QByteArray inKnownCase(QByteArrayView word) {
    for (const char* known : knownWords) {
        if (word.compare(known, Qt::CaseInsensitive) == 0) {
            return known;
        }
    }
    return QByteArray();
}

// Returns the words of a line, as views into it.
std::vector<QByteArrayView> wordsOf(QByteArrayView line) {
    const auto isSpace = [](char byte) { return byte == ' ' || byte == '\t'; };
    std::vector<QByteArrayView> words;
    for (auto at = std::find_if_not(line.begin(), line.end(), isSpace); at != line.end();) {
        const auto end = std::find_if(at, line.end(), isSpace);
        words.emplace_back(at, end);
        at = std::find_if_not(end, line.end(), isSpace);
    }
    return words;
}

std::optional<double> numberIn(QByteArrayView word) {
    bool isNumber = false;
    const double number = word.toDouble(&isNumber);
    return isNumber && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

// The options between the first word of a line and the name of its picture.
struct PictureOptions {
    std::size_t end = 1; // index of the first word of the name
    PicturePlacement placement;
    QByteArrayList ignored;
};

// Parses the options of a picture one by one ("MTL material format", Alias Wavefront, "Options for
// texture map statements"). Leaves at least one word for the name.
class OptionReader {
public:
    explicit OptionReader(const std::vector<QByteArrayView>& words) : words_(words) {}

    PictureOptions read() {
        while (options_.end + 1 < words_.size() && readOption()) {
        }
        return options_;
    }

private:
    // Reads one option. Returns false where the name begins.
    bool readOption() {
        const QByteArray option = words_[options_.end].toByteArray().toLower();
        if (option == "-s" || option == "-o" || option == "-t") {
            ++options_.end;
            readVector(option);
        } else if (option == "-mm") { // base and gain of the picture's values
            ++options_.end;
            const auto [base, gain, depth] = numbers(2, {0, 1, 0});
            markIgnoredUnless(base == 0 && gain == 1, option);
        } else if (option == "-clamp") {
            markIgnoredUnless(words_[options_.end + 1].compare("on", Qt::CaseInsensitive) != 0,
                              option);
            skip(2);
        } else if (const QByteArrayList others{"-blendu", "-blendv", "-cc", "-boost", "-texres",
                                               "-bm", "-imfchan", "-type"};
                   others.contains(option)) { // these change no colour
            skip(2);
        } else {
            return false;
        }
        return true;
    }

    void readVector(const QByteArray& option) {
        const float usual = option == "-s" ? 1 : 0;
        const auto [u, v, w] = numbers(3, {usual, usual, usual});
        const Eigen::Vector2f vector(u, v);
        if (option == "-t") { // turbulence
            markIgnoredUnless(vector.isZero() && w == 0, option);
        } else if (option == "-o") {
            options_.placement.offset = vector;
        } else if (u != 0 && v != 0) {
            options_.placement.scale = vector;
        } else {
            markIgnoredUnless(false, option);
        }
    }

    // Reads up to `most` numbers into `found`; the rest keep their values.
    std::array<float, 3> numbers(std::size_t most, std::array<float, 3> found) {
        for (std::size_t i = 0; i < most && options_.end + 1 < words_.size(); ++i) {
            const auto number = numberIn(words_[options_.end]);
            if (!number) {
                break;
            }
            found[i] = float(*number);
            ++options_.end;
        }
        return found;
    }

    void skip(std::size_t words) {
        options_.end = std::min(options_.end + words, words_.size() - 1);
    }

    void markIgnoredUnless(bool isUsual, const QByteArray& option) {
        if (!isUsual && !options_.ignored.contains(option)) {
            options_.ignored.push_back(option);
        }
    }

    const std::vector<QByteArrayView>& words_;
    PictureOptions options_;
};

class Reader {
public:
    Reader(const QByteArray& bytes, const QString& name) : name_(name) {
        file_.bytes = withoutByteOrderMark(bytes);
    }

    MaterialFile read() {
        for (qsizetype begin = 0; begin < file_.bytes.size();) {
            const char* end =
                std::find_if(file_.bytes.cbegin() + begin, file_.bytes.cend(), endsLine);
            const qsizetype next = end - file_.bytes.cbegin();
            readLine(begin, QByteArrayView(file_.bytes).sliced(begin, next - begin).trimmed());
            begin = next + 1;
        }
        if (hasPicture_ || (firstMaterial_ < 0 && hasMaterialLine_)) {
            file_.fault =
                Text::tr("%1 sets material properties before its first material").arg(name_);
        }
        if (firstMaterial_ > 0) {
            file_.bytes = file_.bytes.mid(firstMaterial_);
        }
        return file_;
    }

private:
    void readLine(qsizetype begin, QByteArrayView line) {
        const qsizetype at = line.isEmpty() ? begin : line.data() - file_.bytes.constData();
        const QByteArray word = inKnownCase(firstWord(line));
        if (word == "newmtl" && firstMaterial_ < 0) {
            firstMaterial_ = at;
        }
        if (firstMaterial_ < 0) {
            hasPicture_ |= isPicture(line);
            hasMaterialLine_ |= needsMaterial(line);
        } else if (word == "map_Kd") {
            readPicture(at, line);
        }
        if (word == "newmtl") {
            material_ = QString::fromUtf8(line.sliced(word.size()).trimmed());
        }
        if (!word.isEmpty() && !line.startsWith(word)) {
            file_.bytes.replace(at, word.size(), word);
        }
    }

    // Reads the options of a line that begins at `at`, and overwrites them with blanks.
    void readPicture(qsizetype at, QByteArrayView line) {
        const std::vector<QByteArrayView> words = wordsOf(line);
        const PictureOptions options = OptionReader(words).read();
        file_.placements[material_] = options.placement;
        if (!options.ignored.isEmpty() && file_.warnings.isEmpty()) {
            file_.warnings.push_back(
                Text::tr("Some texture options in %1 are ignored: %2; apply them to the picture in "
                         "a modelling program")
                    .arg(name_, QString::fromLatin1(options.ignored.join(", "))));
        }
        if (options.end > 1) {
            const qsizetype begin = words[1].data() - line.data();
            const qsizetype size = words[options.end].data() - words[1].data();
            file_.bytes.replace(at + begin, size, QByteArray(size, ' '));
        }
    }

    MaterialFile file_;
    QString material_; // the current material
    QString name_;
    qsizetype firstMaterial_ = -1; // position in the file; −1 until it is found
    // Whether a picture, or any line that needs a material, is before the first material.
    bool hasPicture_ = false, hasMaterialLine_ = false;
};

} // namespace

QByteArray withoutByteOrderMark(const QByteArray& text) {
    const auto encoding = QStringConverter::encodingForData(text);
    if (!encoding) {
        return text;
    }
    constexpr qsizetype ofUtf8 = 3; // bytes
    return encoding == QStringConverter::Utf8 ? text.mid(ofUtf8)
                                              : QString(QStringDecoder(*encoding)(text)).toUtf8();
}

MaterialFile materialFile(const QByteArray& bytes, const QString& name) {
    return Reader(bytes, name).read();
}

} // namespace dipwright
