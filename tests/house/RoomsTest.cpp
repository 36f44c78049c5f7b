// Checks the rooms, which are the folders with a CMake target. A room uses another room only by
// linking its target. A room links all rooms that it includes, and none that is above it.
#include "SourceTree.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QtTest>

#include <algorithm>
#include <map>
#include <vector>

namespace {

const QDir source = sourceTree();
const QDir build(QStringLiteral(DIPWRIGHT_BUILD_FOLDER));
// The target that contains dipwright/FilmSolver.h, the only header that core and the solvers share.
const QString solverInterface = QStringLiteral("dipwright_solver_interface");

// One #include line of a source file.
struct Include {
    QString file;   // relative to the source folder
    QString target; // the text between the brackets or quotes
    bool isQuoted = false;
    QString describe() const { return file + QStringLiteral(" includes ") + target; }
};

// One or several folders and their target, as CMake lists them.
struct Room {
    QString target;
    QStringList folders;        // relative to the source folder
    QStringList privateHeaders; // relative to the source folder
    QStringList links;          // all targets that the room links directly
    QStringList handedOn;       // the targets that the room links as PUBLIC or INTERFACE
    QStringList includeFolders; // include folders for the room's sources and for its users
    bool hasUsers = false;      // true for a library, false for a program or plugin
    // "parallel", "core", "solvers", "plugins" or "app"
    QString storey() const { return folders.front().section(QLatin1Char('/'), 0, 0); }
};

std::vector<Include> includesOf(const QString& file) {
    static const QRegularExpression line(QStringLiteral(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"])"),
                                         QRegularExpression::MultilineOption);
    std::vector<Include> includes;
    auto matches = line.globalMatch(textOf(file));
    while (matches.hasNext()) {
        const auto match = matches.next();
        includes.push_back({file, match.captured(2), match.captured(1) == QLatin1String("\"")});
    }
    return includes;
}

std::vector<Include> includesIn(const QString& folder) {
    std::vector<Include> includes;
    for (const QString& file : filesIn(folder, {"*.h", "*.cpp", "*.cu", "*.cuh"})) {
        const std::vector<Include> found = includesOf(file);
        includes.insert(includes.end(), found.begin(), found.end());
    }
    return includes;
}

bool isQt(const Include& include) {
    static const QRegularExpression name(QStringLiteral("^Q[A-Zt]"));
    return !include.isQuoted && name.match(include.target).hasMatch();
}

bool isVtk(const Include& include) {
    return include.target.startsWith(QLatin1String("vtk")) ||
           include.target.startsWith(QLatin1String("QVTK"));
}

// Returns whether the header is of a VTK class that draws or accesses a window.
bool isVtkRendering(const Include& include) {
    static const QRegularExpression name(
        QStringLiteral("^(QVTK|vtk[A-Za-z]*(Render|Actor|Mapper|Camera|Interact|OpenGL|Widget))"));
    return name.match(include.target).hasMatch();
}

// Returns the names of all headers of Qt Widgets, read from the folder of its installation.
QSet<QString> widgetHeaders() {
    const QString folder = QStringLiteral(DIPWRIGHT_WIDGETS_HEADERS);
    const QStringList names =
        folder.isEmpty() ? QStringList() : QDir(folder).entryList(QDir::Files);
    return {names.begin(), names.end()};
}

QStringList texts(const QJsonValue& list) {
    QStringList found;
    for (const auto& entry : list.toArray()) {
        found << entry.toString();
    }
    found.removeAll(QString());
    return found;
}

QStringList relative(const QJsonValue& paths) {
    QStringList found;
    for (const QString& path : texts(paths)) {
        found << source.relativeFilePath(path);
    }
    return found;
}

// Returns the rooms in the order of their declaration, so lower rooms come first.
std::vector<Room> readRooms() {
    QFile file(build.filePath(QStringLiteral("rooms.json")));
    std::vector<Room> rooms;
    if (!file.open(QIODevice::ReadOnly)) {
        return rooms;
    }
    for (const auto& entry : QJsonDocument::fromJson(file.readAll()).array()) {
        const QJsonObject target = entry.toObject();
        const QString type = texts(target["TYPE"]).value(0);
        Room room;
        room.target = target["TARGET"].toString();
        room.folders = relative(target["DIPWRIGHT_FOLDERS"]);
        room.privateHeaders = relative(target["DIPWRIGHT_PRIVATE_HEADERS"]);
        room.handedOn = texts(target["INTERFACE_LINK_LIBRARIES"]);
        room.links = texts(target["LINK_LIBRARIES"]) + room.handedOn;
        room.links.removeDuplicates();
        room.includeFolders =
            texts(target["INCLUDE_DIRECTORIES"]) + texts(target["INTERFACE_INCLUDE_DIRECTORIES"]);
        room.hasUsers = type.endsWith(QLatin1String("LIBRARY")) && !type.startsWith("MODULE");
        rooms.push_back(room);
    }
    return rooms;
}

const std::vector<Room>& allRooms() {
    static const std::vector<Room> rooms = readRooms();
    return rooms;
}

// Returns the name by which other rooms include the header FILE.
QString includedName(const QString& file) {
    static const QRegularExpression above(
        QStringLiteral("^(core/solver/interface|core|solvers|app)/"));
    return QString(file).remove(above);
}

bool isHeader(const QString& file) {
    return file.endsWith(QLatin1String(".h")) || file.endsWith(QLatin1String(".cuh"));
}

// Returns the sources of a room, without its subfolders, which may be rooms themselves.
QStringList sourcesOf(const Room& room) {
    QStringList files;
    for (const QString& folder : room.folders) {
        const QDir here(source.filePath(folder));
        for (const QString& name :
             here.entryList({"*.h", "*.cpp", "*.cu", "*.cuh"}, QDir::Files, QDir::Name)) {
            files << folder + QLatin1Char('/') + name;
        }
    }
    return files;
}

// Maps the name by which a header is included to the header's target.
const std::map<QString, QString>& owners() {
    static const std::map<QString, QString> found = [] {
        std::map<QString, QString> owner{
            {QStringLiteral("dipwright/FilmSolver.h"), solverInterface}};
        for (const Room& room : allRooms()) {
            for (const QString& file : sourcesOf(room)) {
                owner[includedName(file)] = room.target;
            }
        }
        return owner;
    }();
    return found;
}

// Returns the target that owns the header; empty for headers of other projects.
QString ownerOf(const Include& include) {
    const auto found = owners().find(include.target);
    return found == owners().end() ? QString() : found->second;
}

// Returns the targets of other rooms that a room includes, either in its public headers only or in
// all of its sources.
QStringList includedRooms(const Room& room, bool inPublicHeaders) {
    QStringList found;
    for (const QString& file : sourcesOf(room)) {
        if (inPublicHeaders && (!isHeader(file) || room.privateHeaders.contains(file))) {
            continue;
        }
        for (const Include& include : includesOf(file)) {
            found << ownerOf(include);
        }
    }
    found.removeDuplicates();
    found.removeAll(QString());
    found.removeAll(room.target);
    return found;
}

// Returns the TARGETS that are rooms or the solver interface.
QStringList roomsAmong(const QStringList& targets) {
    QStringList found;
    for (const Room& room : allRooms()) {
        if (targets.contains(room.target)) {
            found << room.target;
        }
    }
    return targets.contains(solverInterface) ? found << solverInterface : found;
}

// Returns one line per include that breaks a rule.
template <typename Rule>
QStringList offenders(const QString& folder, const Rule& isForbidden) {
    QStringList lines;
    for (const Include& include : includesIn(folder)) {
        if (isForbidden(include)) {
            lines << include.describe();
        }
    }
    return lines;
}

// Applies RULE to every room and returns all complaints, one per entry.
template <typename Rule>
QStringList complaints(const Rule& rule) {
    QStringList lines;
    for (const Room& room : allRooms()) {
        lines << rule(room);
    }
    return lines;
}

// Returns one line for each entry of LIST that is not in ALLOWED.
QStringList linesFor(const QString& beginning, const QStringList& list,
                     const QStringList& allowed) {
    QStringList lines;
    for (const QString& entry : list) {
        if (!allowed.contains(entry)) {
            lines << beginning + QLatin1Char(' ') + entry;
        }
    }
    return lines;
}

bool isBuiltHere(const QString& folder) {
#ifndef DIPWRIGHT_HAS_CUDA
    if (folder.contains(QLatin1String("cuda"))) {
        return false;
    }
#endif
#ifndef DIPWRIGHT_HAS_WORKBENCH
    if (folder.startsWith(QLatin1String("app/workbench")) ||
        folder == QLatin1String("app/viewport")) {
        return false;
    }
#endif
#ifndef DIPWRIGHT_HAS_PYTHON
    if (folder == QLatin1String("app/python")) {
        return false;
    }
#endif
#ifndef DIPWRIGHT_HAS_INSPECTION
    if (folder == QLatin1String("core/inspection") ||
        folder == QLatin1String("app/workbench/inspection")) {
        return false;
    }
#endif
#ifndef DIPWRIGHT_HAS_CAD
    if (folder == QLatin1String("core/import/cad") || folder == QLatin1String("app/reader/cad")) {
        return false;
    }
#endif
    return !folder.startsWith(QLatin1String("core/solver/interface"));
}

} // namespace

class RoomsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void folders_withSources_areOneRoomEach();
    void rooms_includeFolders_areTheirTargetsOnly();
    void includes_parentFolder_isNotUsed();
    void rooms_includedTargets_areLinked();
    void rooms_linkedTargets_areIncluded();
    void rooms_includesOfPublicHeaders_areLinkedPublic();
    void rooms_linkedRooms_areBelow();
    void settingsRoom_links_onlyBase();
    void privateHeaders_declaration_matchesCMake();
    void solversAndPlugins_qtAndVtk_areNotIncluded();
    void qtWidgets_roomsThatDoNotLinkIt_doNotIncludeIt();
    void vtk_otherFolders_doNotIncludeIt();
    void tbb_otherFolders_doNotIncludeIt();
};

void RoomsTest::folders_withSources_areOneRoomEach() {
    QVERIFY(includesIn(QStringLiteral("core")).size() > 100);
    QStringList roomFolders;
    for (const Room& room : allRooms()) {
        roomFolders << room.folders;
    }
    QStringList folders;
    for (const char* storey : {"parallel", "core", "solvers", "plugins", "app"}) {
        for (const QString& file :
             filesIn(QLatin1String(storey), {"*.h", "*.cpp", "*.cu", "*.cuh"})) {
            folders << file.section(QLatin1Char('/'), 0, -2);
        }
    }
    folders.removeDuplicates();
    folders.removeIf([](const QString& folder) { return !isBuiltHere(folder); });
    folders.sort();
    roomFolders.sort();
    QCOMPARE(roomFolders.join(QLatin1Char('\n')), folders.join(QLatin1Char('\n')));
}

void RoomsTest::rooms_includeFolders_areTheirTargetsOnly() {
    expectNone(complaints([](const Room& room) {
        const QString forwards = build.filePath(QStringLiteral("rooms/") + room.target);
        return linesFor(room.target + QStringLiteral(" looks into"), room.includeFolders,
                        {forwards + "/public", forwards + "/private"});
    }));
}

void RoomsTest::includes_parentFolder_isNotUsed() {
    for (const char* storey : {"parallel", "core", "solvers", "plugins", "app"}) {
        expectNone(offenders(QLatin1String(storey), [](const Include& include) {
            return include.target.contains(QLatin1String("..")) ||
                   QDir::isAbsolutePath(include.target);
        }));
    }
}

void RoomsTest::rooms_includedTargets_areLinked() {
    expectNone(complaints([](const Room& room) {
        return linesFor(room.target + QStringLiteral(" includes, but does not link"),
                        includedRooms(room, false), room.links);
    }));
}

void RoomsTest::rooms_linkedTargets_areIncluded() {
    expectNone(complaints([](const Room& room) {
        return linesFor(room.target + QStringLiteral(" links, but does not include"),
                        roomsAmong(room.links), includedRooms(room, false));
    }));
}

// In CMake, a target that a public header includes is PUBLIC. A target that only sources include is
// PRIVATE.
void RoomsTest::rooms_includesOfPublicHeaders_areLinkedPublic() {
    expectNone(complaints([](const Room& room) -> QStringList {
        if (!room.hasUsers) {
            return {};
        }
        const QStringList needed = includedRooms(room, true);
        return linesFor(room.target + QStringLiteral(" should link as PUBLIC"), needed,
                        room.handedOn) +
               linesFor(room.target + QStringLiteral(" should link as PRIVATE"),
                        roomsAmong(room.handedOn), needed);
    }));
}

// The layers are app → core → solver interface ← solvers ← plugins; `parallel` is below all of
// them. Within a layer, a room links only rooms that are declared earlier (core:
// core/CMakeLists.txt).
void RoomsTest::rooms_linkedRooms_areBelow() {
    const std::map<QString, QStringList> storeys{{"parallel", {}},
                                                 {"core", {"core", "parallel"}},
                                                 {"solvers", {"solvers", "parallel"}},
                                                 {"plugins", {"solvers", "parallel"}},
                                                 {"app", {"core", "app", "parallel"}}};
    QStringList below;
    expectNone(complaints([&](const Room& room) {
        QStringList allowed{solverInterface};
        for (const Room& other : allRooms()) {
            if (below.contains(other.target) &&
                storeys.at(room.storey()).contains(other.storey())) {
                allowed << other.target;
            }
        }
        below << room.target;
        return linesFor(room.target + QStringLiteral(" links a room that is not below it"),
                        roomsAmong(room.links), allowed);
    }));
}

// A room that uses settings must not depend on algorithms.
void RoomsTest::settingsRoom_links_onlyBase() {
    expectNone(complaints([](const Room& room) -> QStringList {
        if (room.target != QLatin1String("dipwright_settings")) {
            return {};
        }
        return linesFor(room.target + QStringLiteral(" links"), roomsAmong(room.links),
                        {QStringLiteral("dipwright_base"), solverInterface});
    }));
}

void RoomsTest::privateHeaders_declaration_matchesCMake() {
    expectNone(complaints([](const Room& room) {
        QStringList saying;
        for (const QString& file : sourcesOf(room)) {
            if (isHeader(file) && textOf(file).contains("Private to this folder.")) {
                saying << file;
            }
        }
        return linesFor(room.target + QStringLiteral(" should keep private"), saying,
                        room.privateHeaders);
    }));
}

void RoomsTest::solversAndPlugins_qtAndVtk_areNotIncluded() {
    for (const char* storey : {"parallel", "solvers", "plugins"}) {
        expectNone(offenders(QLatin1String(storey), [](const Include& include) {
            return isQt(include) || isVtk(include);
        }));
    }
}

void RoomsTest::qtWidgets_roomsThatDoNotLinkIt_doNotIncludeIt() {
    const QSet<QString> widgets = widgetHeaders();
    expectNone(complaints([&](const Room& room) {
        QStringList lines;
        const bool isLinked = room.links.contains(QStringLiteral("Qt6::Widgets"));
        if (isLinked && room.storey() != QLatin1String("app")) {
            lines << room.target + QStringLiteral(" links Qt6::Widgets");
        }
        for (const QString& file : sourcesOf(room)) {
            for (const Include& include : includesOf(file)) {
                if (!isLinked && (widgets.contains(include.target) ||
                                  include.target.startsWith(QLatin1String("QtWidgets")))) {
                    lines << include.describe();
                }
            }
        }
        return lines;
    }));
}

void RoomsTest::vtk_otherFolders_doNotIncludeIt() {
    const auto lives = [](const Include& include, const char* folder) {
        return include.file.startsWith(QLatin1String(folder));
    };
    expectNone(offenders(QStringLiteral("core"), [&](const Include& include) {
        return isVtkRendering(include) ||
               (isVtk(include) && !lives(include, "core/results/") &&
                !lives(include, "core/cradle/FormSurface.cpp") &&    // the surface of a grid
                !lives(include, "core/cradle/ReducedSurface.cpp") && // with fewer triangles
                !lives(include, "core/reduction/"));
    }));
    expectNone(offenders(QStringLiteral("app"), [&](const Include& include) {
        return isVtk(include) && !lives(include, "app/viewport/");
    }));
}

// Only the folder parallel may include oneTBB: there, the thread sanitizer is told how the threads
// of a loop synchronize.
void RoomsTest::tbb_otherFolders_doNotIncludeIt() {
    for (const char* folder : {"core", "solvers", "plugins", "app", "resources", "tests"}) {
        expectNone(offenders(QLatin1String(folder), [](const Include& include) {
            return include.target.startsWith(QLatin1String("tbb/")) ||
                   include.target.startsWith(QLatin1String("oneapi/"));
        }));
    }
}

QTEST_GUILESS_MAIN(RoomsTest)
#include "RoomsTest.moc"
