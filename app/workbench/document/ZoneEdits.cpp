#include "document/ZoneEdits.h"

#include <QCoreApplication>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(ZoneEdits)
};

} // namespace

void addZoneMark(Document& document, const ZoneMark& mark) {
    document.edit(Text::tr("Mark a Zone"), {}, [&](Project& project) {
        std::vector<ZoneMark>& marks = project.tolerance.marks;
        marks.push_back(mark);
        if (marks.size() > mostZoneMarks) {
            marks.erase(marks.begin());
        }
    });
}

void removeLastZoneMark(Document& document) {
    document.edit(Text::tr("Remove Mark"), {}, [](Project& project) {
        if (!project.tolerance.marks.empty()) {
            project.tolerance.marks.pop_back();
        }
    });
}

void removeZoneMarks(Document& document) {
    document.edit(Text::tr("Remove Marks"), {},
                  [](Project& project) { project.tolerance.marks.clear(); });
}

} // namespace dipwright
