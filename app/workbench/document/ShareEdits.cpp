#include "document/ShareEdits.h"

#include <QCoreApplication>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(ShareEdits)
};

} // namespace

void addShareMark(Document& document, const ShareMark& mark) {
    document.edit(Text::tr("Mark for the Join"), QStringLiteral("share.marks"),
                  [&](Project& project) {
                      std::vector<ShareMark>& marks = project.share.marks;
                      marks.push_back(mark);
                      if (marks.size() > mostShareMarks) {
                          marks.erase(marks.begin());
                      }
                  });
}

void removeLastShareMark(Document& document) {
    document.edit(Text::tr("Remove Mark"), {}, [](Project& project) {
        if (!project.share.marks.empty()) {
            project.share.marks.pop_back();
        }
    });
}

void removeShareMarks(Document& document) {
    document.edit(Text::tr("Remove Marks"), {},
                  [](Project& project) { project.share.marks.clear(); });
}

} // namespace dipwright
