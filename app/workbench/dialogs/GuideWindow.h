// The user guide, from Markdown, with its headings as a table of contents.
#pragma once

#include <QWidget>

namespace dipwright {

class GuideWindow : public QWidget {
    Q_OBJECT

public:
    explicit GuideWindow(QWidget* parent = nullptr);
};

} // namespace dipwright
