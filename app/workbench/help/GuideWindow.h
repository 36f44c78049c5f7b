// The user guide, from Markdown, with its headings as a table of contents, and searched.
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

    // False where its chapter has no such words; the chapter is shown then.
    bool showPlace(const GuidePlace& place);

private:
    void showFrom(int position); // on top
    void makeContents();
    void makeSearch();
    void showPlaces(); // marks all that are looked for, shows the first, lists their chapters
    void showNext();   // and from the last one the first again

    QLineEdit* search_;
    QLabel* count_;
    QListWidget* contents_; // each chapter with its position in the text
    QTextBrowser* text_;
};

// The guide where it tells about `widget` (null: where it begins), in a window of its
// own that belongs to `window`.
void showGuide(const QWidget* widget, QWidget& window);

} // namespace dipwright
