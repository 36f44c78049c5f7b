// Pages beside the results, each with who does its work. All belong to the window.
#pragma once

class QMainWindow;

namespace dipwright {

class DipController;
class DipScene;
class DipSession;
class DocumentController;
class DocumentSession;
class JobRunner;
class Messages;
class WindowActions;
class WindowLayout;
class Workbench;

// What pages are made of; it is not kept.
struct PageMakings {
    QMainWindow& window;
    WindowLayout& layout;
    const WindowActions& actions;
    DocumentSession& documents;
    const DipSession& session;
    JobRunner& jobs;
    Messages& messages;
};

// Before WindowLayout::restore().
void addSearchPage(const PageMakings& makings, const Workbench& workbench);
void addArtworkPage(const PageMakings& makings, DipScene& scene, DipController& dip,
                    DocumentController& files);

} // namespace dipwright
