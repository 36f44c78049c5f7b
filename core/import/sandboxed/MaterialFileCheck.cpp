#include "import/sandboxed/MaterialFileCheck.h"

#include <QCoreApplication>
#include <QStringConverter>

#include <algorithm>
#include <cmath>
#include <initializer_list>

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

// At pictures, and what physically based materials have beside their colours, assimp needs a
// material; all else it passes over, a heading such as "Alias OBJ Material File" too.
bool needsMaterial(QByteArrayView line) {
    return startsWithAny(line, {"map_", "bump", "disp", "decal", "refl", "norm"},
                         Qt::CaseInsensitive) ||
           startsWithAny(line, {"a", "Pr", "Pm", "Ps", "Pc"}, Qt::CaseSensitive);
}

QByteArrayView firstWord(QByteArrayView line) {
    return {line.begin(), std::find_if(line.begin(), line.end(),
                                       [](char byte) { return byte == ' ' || byte == '\t'; })};
}

// A line that is one, and no heading that begins like it.
bool isPicture(QByteArrayView line) {
    const QByteArray word = firstWord(line).toByteArray().toLower();
    return word.startsWith("map_") || word == "bump" || word == "disp" || word == "decal" ||
           word == "refl" || word == "norm";
}

bool endsLine(char byte) {
    return byte == '\n' || byte == '\r' || byte == '\f' || byte == '\0';
}

// Words that assimp knows in this case only, and that some programs write in another.
constexpr const char* words[] = {"newmtl", "map_Kd", "Kd"};

QByteArray inKnownCase(QByteArrayView word) {
    for (const char* known : words) {
        if (word.compare(known, Qt::CaseInsensitive) == 0) {
            return known;
        }
    }
    return QByteArray();
}

bool isOther(const QByteArray& word, double usual) {
    bool isNumber = false;
    const double value = word.toDouble(&isNumber);
    return isNumber && std::abs(value - usual) > 1e-6;
}

// Whether a line with a picture places it: by a scale or an offset, of which assimp takes none.
bool movesPicture(QByteArrayView line) {
    const QList<QByteArray> parts = line.toByteArray().simplified().split(' ');
    for (qsizetype at = 1; at + 1 < parts.size(); ++at) {
        const QByteArray option = parts[at].toLower();
        if (option != "-s" && option != "-o") {
            continue;
        }
        const double usual = option == "-s" ? 1 : 0;
        if (isOther(parts[at + 1], usual) || isOther(parts.value(at + 2), usual)) {
            return true;
        }
    }
    return false;
}

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
        if (hasPicture_ || (firstMaterial_ < 0 && hasAny_)) {
            file_.fault = Text::tr("%1 describes a material before it names any").arg(name_);
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
            hasAny_ |= needsMaterial(line);
        } else if (word == "map_Kd" && file_.warnings.isEmpty() && movesPicture(line)) {
            file_.warnings.push_back(
                Text::tr("The scale or offset that %1 gives a texture (-s, -o) is not followed; "
                         "apply it to the texture coordinates in a modelling program")
                    .arg(name_));
        }
        if (!word.isEmpty() && !line.startsWith(word)) {
            file_.bytes.replace(at, word.size(), word);
        }
    }

    MaterialFile file_;
    QString name_;
    qsizetype firstMaterial_ = -1;             // where it begins
    bool hasPicture_ = false, hasAny_ = false; // before that
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
