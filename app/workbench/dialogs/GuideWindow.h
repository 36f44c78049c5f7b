// The user guide, from Markdown, with its headings as a table of contents, and searched.
#pragma once

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

private:
    void makeContents();
    void makeSearch();
    void showPlaces(); // marks all that are looked for, shows the first, lists their chapters
    void showNext();   // and from the last one the first again

    QLineEdit* search_;
    QLabel* count_;
    QListWidget* contents_; // each chapter with its position in the text
    QTextBrowser* text_;
};

} // namespace dipwright
