#include "import/sandboxed/ColladaCheck.h"

#include <QCoreApplication>
#include <QHash>
#include <QXmlStreamReader>

#include <algorithm>
#include <vector>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::ImportModel)
};

struct Accessor {
    QString array;
    double end = 0; // number of array values that the accessor reads; may be absurd
};

double number(const QXmlStreamAttributes& attributes, const char* name, double otherwise) {
    const QLatin1String key(name);
    return attributes.hasAttribute(key) ? attributes.value(key).toDouble() : otherwise;
}

qsizetype wordCount(const QString& text) {
    qsizetype words = 0;
    bool inWord = false;
    for (const QChar letter : text) {
        words += !letter.isSpace() && !inWord;
        inWord = !letter.isSpace();
    }
    return words;
}

bool isWholeNumbers(const QString& text, bool areSigned) {
    return std::all_of(text.begin(), text.end(), [&](QChar letter) {
        return letter.isSpace() || (letter >= u'0' && letter <= u'9') ||
               (areSigned && letter == u'-');
    });
}

// Elements that hold indices. assimp loops for ever at a word in them that is not a number.
const QStringList indexLists{QStringLiteral("p"), QStringLiteral("h"), QStringLiteral("v"),
                             QStringLiteral("vcount")};
// The element among them (vertex weights) in which −1 is a valid value.
const QString signedIndexList = QStringLiteral("v");

// Refuses images without a file name, on which assimp 5.2.5 ends. Collada 1.5 names files
// otherwise.
class ImageCheck {
public:
    void check(QXmlStreamReader& xml, const ModelSource& source) {
        const qint64 line = xml.lineNumber();
        if (xml.name() == u"COLLADA") {
            isNewer_ = xml.attributes().value(QLatin1String("version")).startsWith(u"1.5");
        } else if (xml.name() == u"image" || xml.name() == u"surface") {
            isInImage_ = xml.name() == u"image";
        } else if (xml.name() == u"init_from" && isInImage_ && !isNewer_ &&
                   xml.readElementText(QXmlStreamReader::SkipChildElements).trimmed().isEmpty()) {
            source.throwDamaged(
                Text::tr("the image in line %1 has no file name (Collada 1.4 has it directly in "
                         "init_from)")
                    .arg(line));
        }
    }

private:
    bool isNewer_ = false, isInImage_ = false;
};

// Refuses an element that assimp 5.2.5 reads in another shape, or that ends it.
void checkShape(QXmlStreamReader& xml, const ModelSource& source) {
    const QStringView name = xml.name();
    const auto refuse = [&](const QString& reason) {
        source.throwDamaged(reason.arg(xml.lineNumber()));
    };
    if (name == u"trifans") {
        refuse(Text::tr("line %1 has fans of triangles, which are not supported (export the model "
                        "as triangles)"));
    } else if (name == u"skew") {
        refuse(Text::tr("line %1 skews a node, which is not supported (apply the transforms in a "
                        "modelling program)"));
    } else if (name == u"rotate") {
        const QStringList numbers = xml.readElementText().simplified().split(u' ');
        const auto number = [&](int index) { return numbers.value(index).toDouble(); };
        if (number(3) != 0 && !isUnit({number(0), number(1), number(2)})) {
            refuse(Text::tr("line %1 turns a node about an axis whose length is not 1, so it would "
                            "change the shape (apply the transforms in a modelling program)"));
        }
    }
}

} // namespace

bool isCollada(const QByteArray& begin) {
    return begin.contains("<COLLADA");
}

void checkCollada(const ModelSource& source) {
    QHash<QString, double> lengths; // array lengths by name
    std::vector<Accessor> accessors;
    ImageCheck images;
    double missingPolygons = 0;
    QXmlStreamReader xml(source.bytes);
    while (!xml.atEnd()) {
        const QXmlStreamReader::TokenType token = xml.readNext();
        // assimp 5.2.5 aborts if the number of polygons differs from the declared count.
        if (token == QXmlStreamReader::EndElement && xml.name() == u"polygons" &&
            missingPolygons != 0) {
            source.throwDamaged(
                Text::tr("the number of polygons before line %1 differs from the declared count")
                    .arg(xml.lineNumber()));
        }
        if (token != QXmlStreamReader::StartElement) {
            continue;
        }
        const QXmlStreamAttributes attributes = xml.attributes();
        missingPolygons = xml.name() == u"polygons" ? number(attributes, "count", 0)
                                                    : missingPolygons - (xml.name() == u"p");
        // assimp allocates memory for this number of values at once.
        if (number(attributes, "count", 0) > double(source.bytes.size())) {
            source.throwDamaged(Text::tr("line %1 declares more values than the file can hold")
                                    .arg(xml.lineNumber()));
        }
        if (xml.name().endsWith(QLatin1String("_array"))) {
            const double count = number(attributes, "count", 0);
            const auto words = double(wordCount(xml.readElementText()));
            lengths.insert(attributes.value(QLatin1String("id")).toString(),
                           std::min(count, words));
        } else if (indexLists.contains(xml.name())) {
            const bool areSigned = xml.name() == signedIndexList;
            if (!isWholeNumbers(xml.readElementText(QXmlStreamReader::SkipChildElements),
                                areSigned)) {
                source.throwDamaged(
                    Text::tr("line %1 has no number where one is expected").arg(xml.lineNumber()));
            }
        } else if (xml.name() == QLatin1String("accessor")) {
            accessors.push_back(
                {attributes.value(QLatin1String("source")).mid(1).toString(),
                 number(attributes, "offset", 0) +
                     number(attributes, "count", 0) * number(attributes, "stride", 1)});
        } else {
            images.check(xml, source);
            checkShape(xml, source);
        }
    }
    if (xml.hasError()) {
        source.throwDamaged(xml.errorString());
    }
    for (const Accessor& accessor : accessors) {
        if (!(accessor.end >= 0 && accessor.end <= lengths.value(accessor.array))) {
            source.throwDamaged(Text::tr("its array %1 has fewer values than an accessor reads")
                                    .arg(accessor.array));
        }
    }
}

} // namespace dipwright
