#include "workbench/widgets/ReplaceQuestion.h"

#include <QCoreApplication>
#include <QDir>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::ReplaceQuestion)
};

constexpr qsizetype mostNamed = 6; // number of files that are named

} // namespace

bool mayReplace(const QString& folder, const QStringList& files, const QString& title,
                QWidget* parent) {
    QStringList existing;
    for (const QString& file : files) {
        if (QDir(folder).exists(file)) {
            existing << file;
        }
    }
    if (existing.isEmpty()) {
        return true;
    }
    const QString names = existing.size() > mostNamed
                              ? existing.first(mostNamed).join(QStringLiteral(", ")) + u'…'
                              : QLocale().createSeparatedList(existing);
    QMessageBox question(QMessageBox::Warning, title,
                         Text::tr("%1 already contains %2. Replace them?")
                             .arg(QDir::toNativeSeparators(folder), names),
                         QMessageBox::Cancel, parent);
    question.setObjectName(QStringLiteral("replaceQuestion"));
    QPushButton* replace = question.addButton(Text::tr("&Replace"), QMessageBox::DestructiveRole);
    question.setDefaultButton(QMessageBox::Cancel);
    question.exec();
    return question.clickedButton() == replace;
}

} // namespace dipwright
