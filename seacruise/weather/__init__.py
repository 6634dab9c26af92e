"""What she meets: wind from services, from files, generated, or the sample; all of it as `Wind`."""
