#include "dialogs/GuideWindow.h"

#include "dialogs/GuidePictures.h"

#include <QFile>
#include <QListWidget>
#include <QLocale>
#include <QSplitter>
#include <QTextBlock>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace dipwright {

namespace {

constexpr int pictureWidth = 580;

// In the user's language where there is one.
QString guideText() {
    const QString language = QLocale().name();
    for (const QString& suffix :
         {QLatin1Char('.') + language, QLatin1Char('.') + language.section(QLatin1Char('_'), 0, 0),
          QString()}) {
        QFile file(QStringLiteral(":/guide/guide%1.md").arg(suffix));
        if (file.open(QIODevice::ReadOnly)) {
            return QString::fromUtf8(file.readAll());
        }
    }
    return {};
}

} // namespace

GuideWindow::GuideWindow(QWidget* parent) : QWidget(parent, Qt::Window) {
    setObjectName(QStringLiteral("guide"));
    setWindowTitle(tr("User Guide"));
    auto* contents = new QListWidget;
    contents->setAccessibleName(tr("Contents"));
    contents->setFrameShape(QFrame::NoFrame);
    contents->setSpacing(4);
    contents->setWordWrap(true);
    auto* text = new QTextBrowser;
    text->setAccessibleName(tr("User Guide"));
    text->setFrameShape(QFrame::NoFrame);
    text->setOpenExternalLinks(true);
    text->setSearchPaths({QStringLiteral(":/guide")});
    text->document()->setDocumentMargin(24);
    text->setMarkdown(guideText());
    text->document()->addResource(
        QTextDocument::ImageResource,
        QUrl(QStringLiteral("../../docs/pictures/workbench.png")), // as the file itself names it
        QImage(QStringLiteral(":/guide/workbench.png"))
            .scaledToWidth(pictureWidth, Qt::SmoothTransformation));
    for (const QString& name : guidePictures()) {
        text->document()->addResource(QTextDocument::ImageResource,
                                      QUrl(QStringLiteral("../../docs/pictures/%1.png").arg(name)),
                                      guidePicture(name, pictureWidth));
    }
    for (QTextBlock block = text->document()->begin(); block.isValid(); block = block.next()) {
        if (block.blockFormat().headingLevel() == 2) {
            auto* item = new QListWidgetItem(block.text(), contents);
            item->setData(Qt::UserRole, block.position());
        }
    }
    connect(contents, &QListWidget::currentItemChanged, this, [text](const QListWidgetItem* item) {
        QTextCursor cursor(text->document());
        cursor.movePosition(QTextCursor::End);
        text->setTextCursor(cursor); // so that the heading ends up on top
        cursor.setPosition(item->data(Qt::UserRole).toInt());
        text->setTextCursor(cursor);
    });
    auto* splitter = new QSplitter;
    splitter->addWidget(contents);
    splitter->addWidget(text);
    splitter->setStretchFactor(1, 1);
    splitter->setSizes({220, 640});
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(splitter);
    resize(900, 680);
}

} // namespace dipwright
