#include "import/cad/CadFile.h"

#include "base/Error.h"

#include <QCoreApplication>
#include <QSet>

#include <IGESCAFControl_Reader.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_Check.hxx>
#include <Interface_CheckIterator.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <XCAFApp_Application.hxx>
#include <XSControl_TransferReader.hxx>

#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>
#include <new>
#include <sstream>
#include <utility>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::ImportModel)
};

bool isStep(const QByteArray& bytes) {
    constexpr qsizetype longestPrologue = 1000;
    return bytes.left(longestPrologue).trimmed().startsWith("ISO-10303-21");
}

// Each line of an IGES file has 80 columns. Column 73 has the letter of the line's section.
constexpr qsizetype igesColumns = 80, sectionColumn = 72;

// Whether the first line belongs to the start section, or to a flag section.
bool isIges(const QByteArray& bytes) {
    return bytes.size() > sectionColumn &&
           (bytes[sectionColumn] == 'S' || bytes[sectionColumn] == 'F');
}

// Calls `visit` with the columns of each line of an IGES file. The lines end with CR, LF or both,
// or have no ends. They may be followed by blanks.
void forIgesLines(QByteArrayView bytes, const std::function<void(QByteArrayView)>& visit) {
    while (!bytes.isEmpty()) {
        const auto end =
            std::find_if(bytes.begin(), bytes.begin() + std::min(igesColumns, bytes.size()),
                         [](char byte) { return byte == '\r' || byte == '\n'; });
        const qsizetype length = end - bytes.begin();
        if (length > 0) {
            visit(bytes.first(length));
        }
        bytes = bytes.sliced(length < igesColumns ? std::min(length + 1, bytes.size()) : length);
    }
}

// Throws Error if an IGES file does not have the lines that its end states. Its last line, the
// terminate section, has the numbers of lines of the four other sections: S0000001G0000004D…
void requireWhole(const QByteArray& bytes, const QString& path) {
    constexpr qsizetype statedColumns = 8; // of each section
    const QByteArray sections = "SGDP";
    std::array<qint64, 4> counts{};
    QByteArray end;
    forIgesLines(bytes, [&](QByteArrayView line) {
        const char letter = line.size() > sectionColumn ? line[sectionColumn] : ' ';
        if (const qsizetype section = sections.indexOf(letter); section >= 0) {
            ++counts[std::size_t(section)];
        } else if (letter == 'T') {
            end = line.toByteArray();
        }
    });
    for (qsizetype section = 0; section < sections.size(); ++section) {
        const QByteArray stated = end.mid(section * statedColumns, statedColumns);
        if (stated.left(1) != sections.mid(section, 1) ||
            stated.mid(1).trimmed().toLongLong() != counts[std::size_t(section)]) {
            throwDamagedCad(Text::tr("it is incomplete or damaged"), path);
        }
    }
}

template <typename Reader>
void chooseContents(Reader& reader) {
    reader.SetColorMode(true);
    reader.SetNameMode(true);
    reader.SetLayerMode(false);
}

void requireRead(IFSelect_ReturnStatus status, const QString& path) {
    if (status != IFSelect_RetDone) {
        throwDamagedCad(Text::tr("it is damaged"), path);
    }
}

void requireTransferred(bool isDone, const QString& path) {
    if (!isDone) {
        throwDamagedCad(Text::tr("it has no geometry"), path);
    }
}

void readStep(const QByteArray& bytes, const QString& path, CadDocument& result) {
    STEPCAFControl_Reader reader;
    chooseContents(reader);
    reader.SetPropsMode(false);
    reader.SetGDTMode(false);
    reader.SetMatMode(false);
    reader.SetViewMode(false);
    std::istringstream stream(bytes.toStdString());
    requireRead(reader.ChangeReader().ReadStream("model.step", stream), path);
    TColStd_SequenceOfAsciiString lengths, angles, solidAngles;
    reader.ChangeReader().FileUnits(lengths, angles, solidAngles);
    if (!lengths.IsEmpty()) {
        result.unit = QString::fromUtf8(lengths.First().ToCString()).toLower();
    }
    requireTransferred(reader.Transfer(result.document), path);
    result.session = reader.Reader().WS();
}

// OpenCASCADE reads IGES only from named files, or from standard input without a name. In the
// sandbox there are no files, so standard input is replaced by the bytes.
void readIges(const QByteArray& bytes, const QString& path, CadDocument& result) {
#if defined(Q_OS_WIN)
    throwDamagedCad(Text::tr("IGES cannot be read on Windows"), path);
#else
    requireWhole(bytes, path);
    IGESCAFControl_Reader reader;
    chooseContents(reader);
    QByteArray content = bytes;
    std::FILE* const stream = fmemopen(content.data(), std::size_t(content.size()), "r");
    if (!stream) {
        throw std::bad_alloc();
    }
    std::FILE* const before = std::exchange(stdin, stream); // OpenCASCADE closes the stream
    const IFSelect_ReturnStatus status = reader.ReadFile("");
    stdin = before;
    requireRead(status, path);
    const auto model = Handle(IGESData_IGESModel)::DownCast(reader.WS()->Model());
    if (!model.IsNull() && !model->GlobalSection().UnitName().IsNull()) {
        result.unit = QString::fromUtf8(model->GlobalSection().UnitName()->ToCString()).toLower();
    }
    requireTransferred(reader.Transfer(result.document), path);
    result.session = reader.WS();
    result.isSewn = false;
#endif
}

// Whether the entity describes dimensions or how the file is shown. These are not used, and often
// have types that OpenCASCADE does not know.
bool isLeftOut(const Handle(Standard_Transient) & entity) {
    const QByteArray type(entity.IsNull() ? "" : entity->DynamicType()->Name());
    return type.startsWith("StepVisual_") || type.startsWith("StepDimTol_");
}

// Returns the number of entities that OpenCASCADE could not read from the file or turn into shapes.
int failedEntities(XSControl_WorkSession& session) {
    QSet<int> numbers;
    for (const Interface_CheckIterator& checks :
         {session.ModelCheckList(false), session.TransferReader()->LastCheckList()}) {
        for (checks.Start(); checks.More(); checks.Next()) {
            if (checks.Value()->HasFailed() && !isLeftOut(checks.Value()->Entity())) {
                numbers.insert(checks.Number());
            }
        }
    }
    return int(numbers.size());
}

// Units under the names that everybody knows.
QString plainUnit(const QString& unit) {
    return unit == QLatin1String("millimetre") || unit == QLatin1String("millimeter")
               ? QStringLiteral("mm")
           : unit == QLatin1String("centimetre") || unit == QLatin1String("centimeter")
               ? QStringLiteral("cm")
           : unit == QLatin1String("metre") || unit == QLatin1String("meter") ? QStringLiteral("m")
           : unit == QLatin1String("in") ? QStringLiteral("inch")
                                         : unit.simplified().left(20);
}

} // namespace

void throwDamagedCad(const QString& reason, const QString& path) {
    throw Error(Text::tr("The CAD file cannot be read: %1; save it again as STEP (AP214 or AP242) "
                         "in the CAD program")
                    .arg(reason),
                path);
}

CadDocument cadDocument(const QByteArray& bytes, const QString& path) {
    CadDocument result;
    XCAFApp_Application::GetApplication()->NewDocument("BinXCAF", result.document);
    if (isStep(bytes)) {
        readStep(bytes, path, result);
    } else if (isIges(bytes)) {
        readIges(bytes, path, result);
    } else {
        throwDamagedCad(Text::tr("it is neither STEP nor IGES"), path);
    }
    result.unit = plainUnit(result.unit);
    result.failedEntities = failedEntities(*result.session);
    return result;
}

} // namespace dipwright
