#include "import/sandboxed/ColladaTextureSets.h"

#include <QCoreApplication>
#include <QXmlStreamReader>

#include <iterator>
#include <map>
#include <optional>
#include <set>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::ImportModel)
};

const QLatin1String texcoord("texcoord"), texcoordSemantic("TEXCOORD");

constexpr int noSet = -1;

// What a file says about its texture coordinates. A set is the number in an attribute `set`.
struct Bindings {
    std::set<QString> symbols;              // the symbols that textures use
    std::map<QString, std::set<int>> bound; // sets to which a symbol is bound
    std::set<std::set<int>> sets;           // the sets of each group of faces with several
};

class BindingsReader {
public:
    Bindings read(const QByteArray& file) {
        QXmlStreamReader xml(file);
        while (!xml.atEnd()) {
            if (xml.readNext() == QXmlStreamReader::StartElement) {
                readElement(xml.name(), xml.attributes());
            }
        }
        return bindings_;
    }

private:
    void readElement(QStringView name, const QXmlStreamAttributes& attributes) {
        const auto value = [&](const char* key) { return attributes.value(QLatin1String(key)); };
        if (name == QLatin1String("input")) { // the inputs of a group of faces follow each other
            if (value("semantic") == texcoordSemantic) {
                inputs_.insert(value("set").toInt());
            }
            return;
        }
        if (inputs_.size() > 1) {
            bindings_.sets.insert(inputs_);
        }
        inputs_.clear();
        if (name == QLatin1String("texture")) {
            bindings_.symbols.insert(attributes.value(texcoord).toString());
        } else if (name == QLatin1String("bind_vertex_input") &&
                   value("input_semantic") == texcoordSemantic) {
            bool isNumber = false;
            const int set = value("input_set").toInt(&isNumber);
            bindings_.bound[value("semantic").toString()].insert(isNumber ? set : noSet);
        }
    }

    Bindings bindings_;
    std::set<int> inputs_; // sets of the present group of faces
};

// Returns the index of a symbol's set among the sets of every group of faces; nothing if the file
// does not say it, or if groups differ.
std::optional<int> indexOf(const QString& symbol, const Bindings& bindings) {
    if (bindings.sets.empty()) {
        return 0;
    }
    const auto bound = bindings.bound.find(symbol);
    if (bound == bindings.bound.end() || bound->second.size() != 1) {
        return std::nullopt;
    }
    std::set<int> indices;
    for (const std::set<int>& sets : bindings.sets) {
        const auto found = sets.find(*bound->second.begin());
        indices.insert(found == sets.end() ? noSet : int(std::distance(sets.begin(), found)));
    }
    return indices.size() == 1 && *indices.begin() != noSet ? std::optional(*indices.begin())
                                                            : std::nullopt;
}

// Replaces the symbol of textures by another that contains `index`. Returns false if the file
// writes the symbol in an unusual way.
bool setIndex(QByteArray& file, const QString& symbol, int index) {
    bool isFound = false;
    for (const char quote : {'"', '\''}) {
        const QByteArray key = QByteArray(texcoord.data()) + '=' + quote;
        const QByteArray before = key + symbol.toUtf8() + quote;
        isFound |= file.contains(before);
        file.replace(before, key + "Dipwright" + QByteArray::number(index) + quote);
    }
    return isFound;
}

} // namespace

QByteArray withTextureSets(const ModelSource& source, QStringList& warnings) {
    QByteArray file = source.bytes;
    if (!source.withTextures || !file.contains(texcoord.data())) {
        return file;
    }
    const Bindings bindings = BindingsReader().read(file);
    bool isClear = true;
    for (const QString& symbol : bindings.symbols) {
        const std::optional<int> index = indexOf(symbol, bindings);
        isClear &= index && setIndex(file, symbol, *index);
    }
    if (!isClear && !bindings.sets.empty()) {
        warnings.push_back(unclearTextureSetWarning());
    }
    return file;
}

bool hasTextureThatEnds(const QByteArray& file) {
    if (!file.contains("wrap_")) {
        return false;
    }
    QXmlStreamReader xml(file);
    while (!xml.atEnd()) {
        if (xml.readNext() == QXmlStreamReader::StartElement &&
            (xml.name() == QLatin1String("wrap_s") || xml.name() == QLatin1String("wrap_t"))) {
            const QString mode = xml.readElementText(QXmlStreamReader::SkipChildElements).trimmed();
            if (!mode.isEmpty() && mode != QLatin1String("WRAP")) {
                return true;
            }
        }
    }
    return false;
}

} // namespace dipwright
