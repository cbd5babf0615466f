#include "live/edit_answers.hpp"
namespace mien {
LiveAnswer answer_edit(LiveSession&, const Json&) { return build_refusal(501, "not yet"); }
}
