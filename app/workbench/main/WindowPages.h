// Adds the pages beside the results, each with its controller. The window owns them all.
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

// The objects that a page needs when it is created. Pages do not keep the context.
struct PageContext {
    QMainWindow& window;
    WindowLayout& layout;
    const WindowActions& actions;
    DocumentSession& documents;
    DipSession& session;
    JobRunner& jobs;
    Messages& messages;
};

// Call these before WindowLayout::restore().
void addSearchPage(const PageContext& context, const Workbench& workbench, DipController& dip);
void addArtworkPage(const PageContext& context, DipScene& scene, DipController& dip,
                    DocumentController& files);

} // namespace dipwright
