// Which file to open or to write: folders, names, and what is wrong with them. It draws nothing.
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace pliant::viewer {

class FileChoice {
public:
    // add: to a file that may be there already, which is not replaced.
    enum class Purpose { open, save, add };
    // Does the work with the path; an Error that it throws is told in the dialog, which stays.
    using Chosen = std::function<void(const std::string& path)>;
    struct Entry {
        std::string name;
        bool folder = false;
    };

    // Begins to ask, in the folder of the last answer. `endings`: of the files that are shown, all without one; the first is
    // added to a name to save that has none of them.
    void ask(Purpose purpose, std::string title, std::vector<std::string> endings, std::string name, Chosen chosen);
    bool asking() const { return asking_; }
    // Counts the questions, so that a panel sees a new one.
    int questions() const { return questions_; }
    void cancel() { asking_ = false; }

    Purpose purpose() const { return purpose_; }
    const std::string& title() const { return title_; }
    std::string ending_words() const;  // ".md or .json"
    const std::filesystem::path& folder() const { return folder_; }
    // Folders first, then the files with the ending, or all of them; by name.
    const std::vector<Entry>& entries() const { return entries_; }
    bool all_files() const { return all_files_; }
    void show_all_files(bool all);

    std::string name;  // as typed: a name, or a path that may begin with ~

    // A folder that cannot be read is told in words and not gone to.
    void go_to(const std::filesystem::path& folder);
    void go_up();
    // Takes the name of the entry that stands so many before or after the one that is named now.
    void move(int by);
    // Takes what is typed: goes to a folder, or finishes with a file.
    void accept();
    // The question whether to replace a file, and its answers.
    bool asks_to_replace() const { return replacing_; }
    void replace();
    void keep() { replacing_ = false; }
    // What is wrong; "" when nothing is.
    const std::string& complaint() const { return complaint_; }

private:
    std::filesystem::path typed() const;
    bool ends_right(const std::string& name) const;
    void list();
    void finish(const std::filesystem::path& path);

    Purpose purpose_ = Purpose::open;
    std::string title_, complaint_;
    std::vector<std::string> endings_;
    std::filesystem::path folder_;
    std::vector<Entry> entries_;
    Chosen chosen_;
    int questions_ = 0;
    bool asking_ = false, all_files_ = false, replacing_ = false;
};

}  // namespace pliant::viewer
