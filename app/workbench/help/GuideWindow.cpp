#include "workbench/help/GuideWindow.h"

#include "workbench/help/GuidePictures.h"

#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QLocale>
#include <QShortcut>
#include <QSplitter>
#include <QTextBlock>
#include <QTextBrowser>
#include <QVBoxLayout>
#include <algorithm>

namespace dipwright {

namespace {

constexpr int pictureWidth = 580;

// Returns the guide in the user's language, else in English.
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

GuideWindow::GuideWindow(QWidget* parent)
    : QWidget(parent, Qt::Window), search_(new QLineEdit), count_(new QLabel),
      contents_(new QListWidget), text_(new QTextBrowser) {
    setObjectName(QStringLiteral("guide"));
    setWindowTitle(tr("User guide"));
    text_->setAccessibleName(tr("User guide"));
    text_->setFrameShape(QFrame::NoFrame);
    text_->setOpenExternalLinks(true);
    text_->setSearchPaths({QStringLiteral(":/guide")});
    text_->document()->setDocumentMargin(24);
    text_->setMarkdown(guideText());
    text_->document()->addResource(
        QTextDocument::ImageResource,
        QUrl(QStringLiteral("../../docs/pictures/workbench.png")), // the path in the Markdown file
        QImage(QStringLiteral(":/guide/workbench.png"))
            .scaledToWidth(pictureWidth, Qt::SmoothTransformation));
    for (const QString& name : guidePictures()) {
        text_->document()->addResource(QTextDocument::ImageResource,
                                       QUrl(QStringLiteral("../../docs/pictures/%1.png").arg(name)),
                                       guidePicture(name, pictureWidth));
    }
    makeContents();
    makeSearch();
    auto* left = new QWidget;
    auto* column = new QVBoxLayout(left);
    column->setContentsMargins(6, 6, 0, 0);
    column->addWidget(search_);
    column->addWidget(count_);
    column->addWidget(contents_, 1);
    auto* splitter = new QSplitter;
    splitter->addWidget(left);
    splitter->addWidget(text_);
    splitter->setStretchFactor(1, 1);
    splitter->setSizes({220, 640});
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(splitter);
    resize(900, 680);
}

void GuideWindow::makeContents() {
    contents_->setAccessibleName(tr("Contents"));
    contents_->setFrameShape(QFrame::NoFrame);
    contents_->setSpacing(4);
    contents_->setWordWrap(true);
    for (QTextBlock block = text_->document()->begin(); block.isValid(); block = block.next()) {
        if (block.blockFormat().headingLevel() == 2) {
            auto* item = new QListWidgetItem(block.text(), contents_);
            item->setData(Qt::UserRole, block.position());
        }
    }
    connect(contents_, &QListWidget::currentItemChanged, this, [this](const QListWidgetItem* item) {
        if (!item) {
            return;
        }
        showFrom(item->data(Qt::UserRole).toInt());
    });
}

void GuideWindow::showFrom(int position) {
    QTextCursor cursor(text_->document());
    cursor.movePosition(QTextCursor::End);
    text_->setTextCursor(cursor); // scrolls the next cursor position to the top
    cursor.setPosition(position);
    text_->setTextCursor(cursor);
}

bool GuideWindow::showPlace(const GuidePlace& place) {
    search_->clear();
    contents_->setCurrentRow(place.chapter);
    const QListWidgetItem* next = contents_->item(place.chapter + 1);
    const int end = next ? next->data(Qt::UserRole).toInt() : text_->document()->characterCount();
    const int begin = contents_->currentItem()->data(Qt::UserRole).toInt();
    QTextCursor found(text_->document());
    found.setPosition(begin);
    while (
        !place.words.isEmpty() &&
        !(found = text_->document()->find(place.words, found, QTextDocument::FindCaseSensitively))
             .isNull() &&
        found.position() < end) {
        const QTextCharFormat look = found.charFormat();
        if (look.fontWeight() > QFont::Normal || look.fontItalic()) {
            showFrom(found.block().position());
            text_->setTextCursor(found);
            return true;
        }
    }
    showFrom(begin);
    return place.words.isEmpty();
}

void GuideWindow::makeSearch() {
    search_->setObjectName(QStringLiteral("search"));
    search_->setAccessibleName(tr("Search the guide"));
    search_->setPlaceholderText(tr("Search the guide"));
    search_->setToolTip(tr("Press Enter to go to the next match"));
    search_->setClearButtonEnabled(true);
    count_->setObjectName(QStringLiteral("placesFound"));
    count_->hide();
    connect(search_, &QLineEdit::textChanged, this, &GuideWindow::showPlaces);
    connect(search_, &QLineEdit::returnPressed, this, &GuideWindow::showNext);
    auto* find = new QShortcut(QKeySequence::Find, this);
    connect(find, &QShortcut::activated, search_, [this] {
        search_->setFocus();
        search_->selectAll();
    });
}

void GuideWindow::showPlaces() {
    const QString wanted = search_->text().trimmed();
    QList<QTextEdit::ExtraSelection> places;
    for (QTextCursor place(text_->document());
         !wanted.isEmpty() && !(place = text_->document()->find(wanted, place)).isNull();) {
        QTextEdit::ExtraSelection marked;
        marked.cursor = place;
        marked.format.setBackground(palette().highlight());
        marked.format.setForeground(palette().highlightedText());
        places.append(marked);
    }
    text_->setExtraSelections(places);
    for (int row = 0; row < contents_->count(); ++row) {
        const auto positionOf = [this](int chapter) {
            return chapter < contents_->count()
                       ? contents_->item(chapter)->data(Qt::UserRole).toInt()
                       : text_->document()->characterCount();
        };
        const bool holdsOne =
            std::any_of(places.begin(), places.end(), [&](const QTextEdit::ExtraSelection& place) {
                const int position = place.cursor.selectionStart();
                return position >= positionOf(row) && position < positionOf(row + 1);
            });
        contents_->item(row)->setHidden(!wanted.isEmpty() && !holdsOne);
    }
    count_->setVisible(!wanted.isEmpty());
    count_->setText(places.isEmpty() ? tr("No matches") : tr("Matches: %1").arg(places.size()));
    text_->moveCursor(QTextCursor::Start);
    showNext();
}

void GuideWindow::showNext() {
    const QString wanted = search_->text().trimmed();
    if (!wanted.isEmpty() && !text_->find(wanted)) {
        text_->moveCursor(QTextCursor::Start);
        text_->find(wanted);
    }
}

void showGuide(const QWidget* widget, QWidget& window) {
    auto* guide = window.findChild<GuideWindow*>(QString(), Qt::FindDirectChildrenOnly);
    if (!guide) {
        guide = new GuideWindow(&window);
        guide->setAttribute(Qt::WA_DeleteOnClose);
    }
    guide->show();
    guide->raise();
    guide->activateWindow();
    guide->showPlace(guidePlaceOf(widget));
}

} // namespace dipwright
