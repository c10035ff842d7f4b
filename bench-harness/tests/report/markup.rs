//! The elements of a page, checked: every one that is opened is closed, in order.

/// Elements without an end.
const VOID: [&str; 3] = ["meta", "link", "br"];

/// A tag: what stands between `<` and `>`.
pub(crate) fn tags(page: &str) -> impl Iterator<Item = &str> {
    page.split('<').skip(1).map(|rest| {
        let (tag, _) = rest.split_once('>').expect("a tag ends");
        tag
    })
}

/// What is wrong with the nesting of the elements of `page`.
pub(crate) fn fault(page: &str) -> Option<String> {
    let mut open = Vec::new();
    for tag in tags(page) {
        let name = |tag: &str| tag.split_whitespace().next().unwrap_or_default().to_owned();
        if tag.starts_with('!') || tag.ends_with('/') || VOID.contains(&name(tag).as_str()) {
            continue;
        }
        match tag.strip_prefix('/') {
            None => open.push(name(tag)),
            Some(end) => match open.pop() {
                Some(begun) if begun == end => {}
                begun => return Some(format!("</{end}> closes {begun:?}")),
            },
        }
    }
    open.pop().map(|name| format!("<{name}> is never closed"))
}

#[test]
fn a_fault_is_found() {
    assert_eq!(fault("<!DOCTYPE html><p>a<meta x><rect y/></p>"), None);
    assert!(fault("<p><b></p></b>").is_some());
    assert!(fault("<p>").is_some());
}
