#include "workbench/document/MarkEdits.h"

#include <QCoreApplication>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(MarkEdits)
};

template <typename Mark>
struct Marks;

template <>
struct Marks<ShareMark> {
    static constexpr std::size_t most = mostShareMarks;
    static std::vector<ShareMark>& of(Project& project) { return project.share.marks; }
};

template <>
struct Marks<ZoneMark> {
    static constexpr std::size_t most = mostZoneMarks;
    static std::vector<ZoneMark>& of(Project& project) { return project.tolerance.marks; }
};

template <typename Mark>
void add(Document& document, const QString& text, const QString& mergeKey, const Mark& mark) {
    document.edit(text, mergeKey, [&](Project& project) {
        std::vector<Mark>& marks = Marks<Mark>::of(project);
        marks.push_back(mark);
        if (marks.size() > Marks<Mark>::most) {
            marks.erase(marks.begin());
        }
    });
}

} // namespace

void addMark(Document& document, const ShareMark& mark) {
    add(document, Text::tr("Mark area for the seam"), QStringLiteral("share.marks"), mark);
}

void addMark(Document& document, const ZoneMark& mark) {
    add(document, Text::tr("Mark zone"), QStringLiteral("tolerance.marks"), mark);
}

template <typename Mark>
void removeLastMark(Document& document) {
    document.edit(Text::tr("Remove mark"), {}, [](Project& project) {
        std::vector<Mark>& marks = Marks<Mark>::of(project);
        if (!marks.empty()) {
            marks.pop_back();
        }
    });
}

template <typename Mark>
void removeMarks(Document& document) {
    document.edit(Text::tr("Remove marks"), {},
                  [](Project& project) { Marks<Mark>::of(project).clear(); });
}

template void removeLastMark<ShareMark>(Document&);
template void removeLastMark<ZoneMark>(Document&);
template void removeMarks<ShareMark>(Document&);
template void removeMarks<ZoneMark>(Document&);

} // namespace dipwright
