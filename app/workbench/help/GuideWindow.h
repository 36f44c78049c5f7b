// The window with the user guide, its table of contents and a search.
#pragma once

#include "workbench/help/GuidePlaces.h"

#include <QWidget>

class QLabel;
class QLineEdit;
class QListWidget;
class QTextBrowser;

namespace dipwright {

class GuideWindow : public QWidget {
    Q_OBJECT

public:
    explicit GuideWindow(QWidget* parent = nullptr);

    // Shows the place. If the chapter does not contain the words, shows the chapter's beginning and
    // returns false.
    bool showPlace(const GuidePlace& place);

private:
    void showFrom(int position); // scrolls `position` to the top
    void makeContents();
    void makeSearch();
    void showPlaces(); // marks all matches, shows the first, lists their chapters
    void showNext();   // shows the next match; after the last, the first

    QLineEdit* search_;
    QLabel* count_;
    QListWidget* contents_; // each chapter with its position in the text
    QTextBrowser* text_;
};

// Opens the guide at the place for `widget` (null: its beginning). Its window is a child of
// `window`.
void showGuide(const QWidget* widget, QWidget& window);

} // namespace dipwright
